// says: Syntax.java:2: error: illegal start of expression
public class Syntax { public static void main(String[] a){ int x = ; } }
