package steward.league.store;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;

/** A database as an earlier form of the program had it, with the rows of today. */
public final class OlderForm {

    private OlderForm() { }

    /** Takes away what later forms have added. */
    public static void of(Path database, int form) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database);
             Statement statement = connection.createStatement()) {
            for (String table : new String[] {"season", "version", "machine", "lineup", "game"}) {
                statement.execute("ALTER TABLE " + table + " DROP COLUMN digest");
            }
            statement.execute("ALTER TABLE version DROP COLUMN paused");
            statement.execute("ALTER TABLE version DROP COLUMN time_limit");
            statement.execute("PRAGMA writable_schema = ON");
            statement.execute("UPDATE sqlite_schema SET sql = replace(replace(sql, ', STRICT', ''), ' STRICT', '')");
            statement.execute("PRAGMA writable_schema = RESET");
            if (form < 3) {
                statement.execute("ALTER TABLE game DROP COLUMN transcript");
                statement.execute("ALTER TABLE seat DROP COLUMN own");
            }
            if (form < 2) {
                statement.execute("ALTER TABLE season DROP COLUMN lower_is_better");
            }
            statement.execute("PRAGMA user_version = " + form);
        }
    }
}
