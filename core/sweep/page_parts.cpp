// Written by hand: no library, no request to anywhere.
#include "sweep/page_parts.h"

namespace isoscope::sweep {

const char* const page_style = R"css(
:root{--ground:#fbfaf8;--card:#fff;--text:#22262c;--quiet:#6d737c;--line:#e6e2db;--hover:#f4f1ec;--accent:#2d6f94;
--certified:#3f8f6b;--uncertified:#c98f22;--stopped:#7c7fae;--refused:#8d939c;--missing:#b3b0a9;--time:#b5672d;
--memory:#8a5a9e;--crashed:#c2463a;--failed:#a83a5b;
--s0:#2d6f94;--s1:#6aa5c4;--s2:#a9cfe0;--s3:#c9a36b;--s4:#e0c79d;--s5:#9aa0a8;color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--ground:#15171b;--card:#1b1e23;--text:#e6e4df;--quiet:#979da6;--line:#2c3037;
--hover:#22262c;--accent:#7ab8d8;--certified:#62b48e;--uncertified:#dfae4e;--stopped:#9fa2d2;--refused:#858c96;
--missing:#6f6d69;--time:#d58b52;--memory:#b58ac8;--crashed:#e26d61;--failed:#d4688a;
--s0:#5b9fc4;--s1:#3f7594;--s2:#2d5268;--s3:#c9a36b;--s4:#8f7447;--s5:#6d737c}}
*{box-sizing:border-box}
body{font:15px/1.5 Inter,"Helvetica Neue",Helvetica,Arial,sans-serif;color:var(--text);background:var(--ground);
max-width:76rem;margin:0 auto;padding:2.4rem 1.6rem 5rem;font-feature-settings:"tnum"}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 .3rem;font-weight:600;letter-spacing:-.01em}
p{margin:.2rem 0;color:var(--quiet)}code{font:.85em "JetBrains Mono",ui-monospace,monospace;color:var(--text)}
.bar{display:flex;height:10px;border-radius:5px;overflow:hidden;margin:1.4rem 0 .7rem;gap:2px}
.bar span{min-width:3px;background:var(--c)}
.chips{display:flex;flex-wrap:wrap;gap:.45rem;align-items:center}
.chips button{font:inherit;font-size:.85rem;color:var(--text);background:none;border:1px solid var(--line);
border-radius:1rem;padding:.12rem .75rem .12rem .6rem;cursor:pointer}
.chips button:hover{background:var(--hover)}.chips button[aria-pressed=true]{border-color:var(--c,var(--accent));
background:var(--hover)}
.dot{display:inline-block;width:.55rem;height:.55rem;border-radius:50%;background:var(--c);margin-right:.45rem}
.chips input{font:inherit;font-size:.85rem;margin-left:auto;padding:.16rem .7rem;border:1px solid var(--line);
border-radius:1rem;background:var(--card);color:var(--text);min-width:13rem}
:focus-visible{outline:2px solid var(--accent);outline-offset:1px}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(15rem,1fr));gap:1rem;margin:1.6rem 0 .5rem}
.plots figure{margin:0;background:var(--card);border:1px solid var(--line);border-radius:8px;padding:.7rem .8rem .4rem}
.histogram{width:100%;height:auto;display:block}.histogram text{font-size:10px;fill:var(--text)}
.histogram .title{font-weight:600;font-size:11px}.histogram .quiet{fill:var(--quiet)}.histogram .axis{fill:var(--line)}
.s0{fill:var(--s0);background:var(--s0)}.s1{fill:var(--s1);background:var(--s1)}.s2{fill:var(--s2);background:var(--s2)}
.s3{fill:var(--s3);background:var(--s3)}.s4{fill:var(--s4);background:var(--s4)}.s5{fill:var(--s5);background:var(--s5)}
.key{font-size:.85rem;color:var(--quiet);display:flex;gap:1.1rem;margin:0 0 1.6rem;flex-wrap:wrap}
.key i{display:inline-block;width:.7rem;height:.7rem;border-radius:2px;margin-right:.4rem;vertical-align:-1px}
table{border-collapse:collapse;width:100%}th,td{padding:.3rem .7rem;text-align:right;border-bottom:1px solid var(--line);
vertical-align:middle}
th{position:sticky;top:0;background:var(--ground);font-weight:500;font-size:.82rem;color:var(--quiet);
white-space:nowrap;cursor:pointer;user-select:none;z-index:2;box-shadow:0 1px 0 var(--line)}
th:hover,th[aria-sort]{color:var(--text)}th[aria-sort=ascending]:after{content:" \2191"}
th[aria-sort=descending]:after{content:" \2193"}
td.l,th.l{text-align:left}tbody tr:hover{background:var(--hover)}
td.picture{padding:.2rem .3rem;width:116px;text-align:center}
td.picture img{width:112px;height:84px;display:block;transition:transform .16s;position:relative}
td.picture img:hover{transform:scale(2.6) translateX(28%);z-index:3;background:var(--card);border-radius:5px;
box-shadow:0 3px 14px rgba(0,0,0,.28)}
td.model{overflow-wrap:anywhere}td a{color:inherit;text-decoration:none;border-bottom:1px solid var(--line)}
td a:hover{color:var(--accent);border-color:currentColor}
.outcome{white-space:nowrap}.words{font-size:.85rem;color:var(--quiet);max-width:22rem;overflow-wrap:anywhere}
.none{color:var(--quiet)}
h2{font-size:1.05rem;font-weight:600;margin:2rem 0 .5rem}h2 small{font-weight:400;color:var(--quiet);margin-left:.3rem}
ul{list-style:none;margin:0;padding:0}li{padding:.32rem 0 .32rem 1rem;border-bottom:1px solid var(--line);color:var(--quiet)}
li b{font-weight:500;color:var(--text)}
@media (max-width:60rem){td.words,th.words{display:none}}
@media (prefers-reduced-motion:reduce){td.picture img{transition:none}}
)css";

const char* const page_script = R"js(
'use strict';
const data = JSON.parse(document.getElementById('rows').textContent);
const body = document.querySelector('tbody'), end = document.getElementById('end');
const heads = [...document.querySelectorAll('th[data-key]')], chips = [...document.querySelectorAll('.chips button')];
const search = document.querySelector('.chips input'), told = document.getElementById('told');
const at = {run: 0, model: 1, tolerance: 2, outcome: 3, vertices: 4, chi: 5, covers: 6, seconds: 7, memory: 8, words: 9};
const collator = new Intl.Collator(undefined, {numeric: true});
let shown = [], next = 0, key = 'run', down = false;

const cell = (row, text, style) => {
  const td = row.insertCell();
  if (style) td.className = style;
  td.textContent = text === null ? '–' : text;
  if (text === null) td.classList.add('none');
  return td;
};
const number = (value, digits) => value === null ? null
  : value.toLocaleString('en', {maximumFractionDigits: digits, minimumFractionDigits: digits});
const line = r => {
  const row = document.createElement('tr'), picture = row.insertCell();
  picture.className = 'picture';
  if (r[11]) {
    const image = picture.appendChild(document.createElement('img'));
    image.loading = 'lazy'; image.alt = ''; image.width = 112; image.height = 84; image.src = r[11];
  }
  const model = cell(row, r[10] ? '' : r[1], 'l model');
  if (r[10]) {
    const link = model.appendChild(document.createElement('a'));
    link.href = r[10]; link.textContent = r[1];
  }
  cell(row, data.tolerances[r[2]]);
  const outcome = cell(row, '', 'l outcome'), dot = outcome.appendChild(document.createElement('span'));
  dot.className = 'dot'; dot.style.setProperty('--c', 'var(--' + data.outcomes[r[3]][1] + ')');
  outcome.append(data.outcomes[r[3]][0]);
  cell(row, number(r[4], 0)); cell(row, r[5] === null ? null : String(r[5]).replace('-', '−'));
  cell(row, number(r[6], 2)); cell(row, number(r[7], 2)); cell(row, number(r[8], 0)); cell(row, r[9], 'l words');
  return row;
};
const more = () => {
  const lines = document.createDocumentFragment();
  for (const stop = Math.min(shown.length, next + 60); next < stop; ++next) lines.append(line(shown[next]));
  body.append(lines);
};
const fill = () => {
  const part = search.value.trim().toLowerCase(), k = at[key];
  const wanted = chips.filter(c => c.getAttribute('aria-pressed') === 'true').map(c => Number(c.dataset.outcome));
  shown = data.rows.filter(r => (!wanted.length || wanted.includes(r[3])) &&
    (!part || (r[1] + ' ' + data.tolerances[r[2]] + ' ' + r[9]).toLowerCase().includes(part)));
  const order = (a, b) => {
    if (a[k] === null || b[k] === null) return (a[k] === null) - (b[k] === null); // what is not there comes last
    const found = typeof a[k] === 'string' ? collator.compare(a[k], b[k]) : a[k] - b[k];
    return down ? -found : found;
  };
  shown.sort((a, b) => order(a, b) || a[0] - b[0]);
  body.textContent = ''; next = 0; more();
  told.textContent = shown.length === data.rows.length ? '' : shown.length + ' of ' + data.rows.length;
  for (const h of heads)
    if (h.dataset.key === key) h.setAttribute('aria-sort', down ? 'descending' : 'ascending');
    else h.removeAttribute('aria-sort');
};
for (const h of heads) {
  h.tabIndex = 0;
  h.onclick = () => { down = h.dataset.key === key ? !down : h.dataset.first === 'down'; key = h.dataset.key; fill(); };
  h.onkeydown = e => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); h.click(); } };
}
for (const c of chips) c.onclick = () => {
  c.setAttribute('aria-pressed', c.getAttribute('aria-pressed') !== 'true'); fill();
};
search.oninput = fill;
new IntersectionObserver(seen => { if (seen[0].isIntersecting) more(); }, {rootMargin: '900px'}).observe(end);
fill();
)js";

} // namespace isoscope::sweep
