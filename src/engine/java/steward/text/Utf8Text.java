package steward.text;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;

/** Strict decoder of UTF-8 texts: unlike {@code new String}, it says where a text is not UTF-8. */
public final class Utf8Text {

    private static final int BUFFER = 1 << 13;

    private Utf8Text() { }

    /** Bytes that are not UTF-8; the message says where and which. */
    public static final class NotUtf8Exception extends CharacterCodingException {

        private final String message;

        NotUtf8Exception(String message) {
            this.message = message;
        }

        @Override
        public String getMessage() {
            return message;
        }
    }

    /**
     * Decodes a text.
     *
     * @param source   names it in the message
     * @param expected ends the message, such as "a text in UTF-8"
     */
    public static String decode(byte[] bytes, String source, String expected) throws NotUtf8Exception {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException found) {
            try {
                throw problem(new ByteArrayInputStream(bytes), source, expected);
            } catch (NotUtf8Exception place) {
                throw place;
            } catch (IOException inMemory) {
                throw new UncheckedIOException(inMemory);
            }
        }
    }

    /**
     * The first place in a text that is not UTF-8, line and column counted from 1, a column for each character.
     *
     * @param in read from its beginning
     * @throws IllegalArgumentException if all of it is UTF-8
     */
    public static NotUtf8Exception problem(InputStream in, String source, String expected) throws IOException {
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
        ByteBuffer bytes = ByteBuffer.allocate(BUFFER);
        CharBuffer text = CharBuffer.allocate(BUFFER);
        int line = 1;
        int column = 1;
        for (;;) {
            int count = in.read(bytes.array(), bytes.position(), bytes.remaining());
            boolean isEnd = count < 0;
            bytes.position(bytes.position() + Math.max(0, count)).flip();
            CoderResult result = decoder.decode(bytes, text, isEnd);
            for (char character : text.flip().toString().toCharArray()) {
                line += character == '\n' ? 1 : 0;
                column = character == '\n' ? 1 : Character.isLowSurrogate(character) ? column : column + 1;
            }
            text.clear();
            if (result.isError()) {
                return new NotUtf8Exception(source + ":" + line + ":" + column + ": found the byte 0x"
                    + String.format("%02X", bytes.get()) + ", which is not UTF-8 here, expected " + expected);
            }
            if (isEnd) {
                throw new IllegalArgumentException(source);
            }
            bytes.compact();
        }
    }
}
