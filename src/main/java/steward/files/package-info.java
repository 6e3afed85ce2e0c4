/** Files that the user named: paths as typed, output that replaces nothing unasked, digests, resources. */
package steward.files;
