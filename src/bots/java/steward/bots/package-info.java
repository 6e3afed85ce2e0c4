/**
 * The bots bundled with Steward: ordinary bot programs for the pod race, each a process of its own that reads frames
 * from its standard input and writes answers to its standard output. They use the JDK and Jackson's streaming reader
 * and nothing of the referee, so that they see no more than any other bot.
 *
 * <p>They are a ladder: each step has one idea more and beats the one below in most games: {@link steward.bots.Racer}
 * steers at its checkpoint, {@link steward.bots.Regular} aims against its drift, {@link steward.bots.Contender} tries
 * moves of one pod ahead, {@link steward.bots.Veteran} tries them among all pods near it and has a pod that blocks the
 * enemy. The README gives the results.
 *
 * <p>Reading and writing ({@link steward.bots.PodBot}, {@code FrameReader}) is separate from deciding
 * ({@code Strategy}). A JVM is started per bot and match, so what runs before the first answer avoids lambdas, string
 * concatenation and formatted text, which would build their call sites at run time.
 */
package steward.bots;
