/**
 * Lines of JSON that programs exchange: numbers to the last digit, objects, walls and drawings written, answers read
 * with messages for who wrote them. JSON that a person writes, with line and column, is the scenes'.
 */
package steward.json;
