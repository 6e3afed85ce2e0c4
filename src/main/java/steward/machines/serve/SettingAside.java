package steward.machines.serve;

/** Sets the games of a machine aside. */
public interface SettingAside {

    /** See {@link steward.league.play.LeagueRun#setAside}. */
    int setAside(String machine, String why) throws InterruptedException;
}
