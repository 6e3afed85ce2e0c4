package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class AnswerReaderTest {

    private static String take(AnswerReader reader, int lines) {
        Answer answer = new Answer();
        assertEquals(AnswerReader.Outcome.COMPLETE, reader.await(lines));
        reader.take(lines, answer);
        return answer.text();
    }

    /** .NET writes one where the encoding of the console is set to UTF-8. */
    @Test
    void aByteOrderMarkIsReadOverOnceAndBeforeEverything() {
        AnswerReader reader = new AnswerReader(new ByteArrayInputStream(
            "\uFEFFa\r\nb\n\uFEFFc\nd".getBytes(StandardCharsets.UTF_8)));
        assertEquals("a\nb", take(reader, 2));
        assertEquals("\uFEFFc", take(reader, 1));
        AnswerReader ended = new AnswerReader(new ByteArrayInputStream("\uFEFFx".getBytes(StandardCharsets.UTF_8)));
        Answer answer = new Answer();
        assertEquals(AnswerReader.Outcome.ENDED, ended.await(1));
        ended.show(answer, 10);
        assertEquals("x", answer.text());
    }
}
