package steward.files;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class UserFoldersTest {

    @Test
    void theHomeIsThatOfTheSystem() {
        assertEquals(Path.of("/home/ann"), UserFolders.home("/home/ann", "/tmp"));
    }

    @Test
    void aUserWithoutAnEntryHasTheVariable() {
        assertEquals(Path.of("/tmp"), UserFolders.home("?", "/tmp"));
        assertEquals(Path.of("?"), UserFolders.home("?", null));
    }
}
