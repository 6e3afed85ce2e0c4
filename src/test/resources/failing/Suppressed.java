// says: Exception in thread "main" java.lang.IllegalStateException: first
public class Suppressed { static class R implements AutoCloseable { public void close(){ throw new IllegalArgumentException("closing", new RuntimeException("why closing")); } } public static void main(String[] a){ try (R r = new R()) { throw new IllegalStateException("first\nsecond"); } } }
