/**
 * JSON lines that programs exchange: writing of exact numbers, objects, walls and drawings, and reading of answers with
 * messages for their authors. JSON that people write, with line and column, belongs to {@code scene}.
 */
package steward.json;
