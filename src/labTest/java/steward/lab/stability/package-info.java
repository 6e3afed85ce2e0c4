/**
 * The stability table: all its cases in order, its rows and files; and the golden hash, which must be the same on every
 * machine.
 */
package steward.lab.stability;
