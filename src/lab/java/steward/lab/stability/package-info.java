/** The stability table, its cases, rows and files; and the golden hash, the same on every machine. */
package steward.lab.stability;
