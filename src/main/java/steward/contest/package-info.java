/**
 * Who plays whom with which seeds and limits: one game or many, on threads, recorded or not, and how each bot did. It
 * does not use the terminal: results are returned, unusable input is thrown as an exception.
 */
package steward.contest;
