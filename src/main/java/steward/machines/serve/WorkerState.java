package steward.machines.serve;

/** What is known of a worker. Guarded by {@link RemoteGames}. */
final class WorkerState {

    final String name;
    int slots;
    String version = "";
    String machine = "";
    long games;
    long checked;
    long began;
    long lastWord;
    boolean caught;

    WorkerState(String name) {
        this.name = name;
    }

    /** How the texts begin that say where its games were played. */
    static String machine(String name) {
        return "worker " + name + ": ";
    }
}
