/** Results of commands: named values and tables, described once and written as text, JSON and CSV. */
package steward.report;
