// ESLint's recommended rules, for the pages' scripts and the browser tests.
import js from '@eslint/js';
import { defineConfig } from 'eslint/config';
import globals from 'globals';

export default defineConfig([
  { ignores: ['**/*.min.js', '**/node_modules/'] },
  js.configs.recommended,
  {
    files: ['book/theme/*.js'],
    languageOptions: { sourceType: 'script', globals: { ...globals.browser, book: 'readonly', MiniSearch: 'readonly' } },
  },
  // This script defines `book`, which the other scripts share.
  { files: ['book/theme/book.js'], languageOptions: { globals: { book: 'off' } } },
  {
    files: ['tests/browser/*.js'],
    languageOptions: { globals: { ...globals.node, ...globals.browser, book: 'readonly' } },
  },
]);
