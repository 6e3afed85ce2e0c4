/** Examples: programs that use Steward as a library, each a single file; compiled and run by the tests. */
package steward.examples;
