/** Examples: programs that use Steward as a library, each one file; compiled and tried by the tests. */
package steward.examples;
