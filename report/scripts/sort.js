// SPDX-License-Identifier: Apache-2.0
// Sorts the table of operations by a column, by what report/pages/html_index.cpp writes as data-sort into its cells. A second
// press turns the order round. The row of sums stays last.
(() => {
'use strict';
for (const table of document.querySelectorAll('table.sortable')) {
  const body = table.querySelector('tbody'), headings = [...table.querySelectorAll('thead th')];
  const key = (row, column) => row.children[column].dataset.sort;
  headings.forEach((heading, column) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = heading.textContent;
    heading.textContent = '';
    heading.append(button);
    button.addEventListener('click', () => {
      const most = heading.classList.contains('most');  // begins with the greatest
      const now = heading.getAttribute('aria-sort');
      const order = now === null ? (most ? 'descending' : 'ascending') : now === 'ascending' ? 'descending' : 'ascending';
      for (const other of headings) other.removeAttribute('aria-sort');
      heading.setAttribute('aria-sort', order);
      const rows = [...body.children], turn = order === 'ascending' ? 1 : -1;
      const compare = (a, b) => {
        const x = key(a, column), y = key(b, column);
        return column === 0 ? (x < y ? -1 : x > y ? 1 : 0) : Number(x) - Number(y);
      };
      const last = rows.filter(row => row.classList.contains('total'));
      const sorted = rows.filter(row => !row.classList.contains('total')).sort((a, b) => turn * compare(a, b));
      body.replaceChildren(...sorted, ...last);
    });
  });
}
})();
