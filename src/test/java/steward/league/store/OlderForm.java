package steward.league.store;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;

/** A database as Steward 0.2.0 had it, with the rows of today. */
public final class OlderForm {

    private OlderForm() { }

    /** Takes away what form 5 has added. */
    public static void of(Path database) throws SQLException {
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
            statement.execute("PRAGMA user_version = 4");
        }
    }
}
