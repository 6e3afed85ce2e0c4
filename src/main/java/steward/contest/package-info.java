/**
 * Who plays whom with which seeds and limits: one game or many, on threads, recorded or not, and how each bot did. It
 * knows no terminal: what it finds it returns, and what cannot be used it throws.
 */
package steward.contest;
