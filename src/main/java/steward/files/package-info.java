/**
 * Files that the user names: paths as typed, output that replaces nothing unless told to, digests, resources, and the
 * exception for unusable input.
 */
package steward.files;
