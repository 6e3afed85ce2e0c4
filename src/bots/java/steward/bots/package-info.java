/**
 * The bots that come with Steward: ordinary bot programs for the pod race, each a process of its own that reads frames
 * from its standard input and writes answers to its standard output. They use the JDK and Jackson's streaming reader
 * and nothing of the referee, so that they see no more than anybody's bot.
 *
 * <p>Reading and writing ({@link steward.bots.PodBot}, {@code Frame}) is apart from deciding ({@code Strategy}). A JVM
 * is started per bot and match, so what runs before the first answer avoids lambdas, string concatenation and formatted
 * text, which would build their call sites at run time.
 */
package steward.bots;
