package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.LeagueFolder;
import steward.machines.token.SharedBrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerPauses;
import steward.machines.token.WorkerToken;

/** Admission of workers that come as soon as they have been added. */
@Tag("process")
@Tag("slow")
class WorkerAdmissionTest {

    private static final int WORKERS = 4;

    @TempDir
    private Path folder;

    /** Several that have just been added come at once: one of them reads the list, and the others wait for it. */
    @Test
    void workersThatHaveJustBeenAddedAreAdmittedTogether() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(WORKERS);
        try {
            for (int round = 0; round < 10; round++) {
                LeagueFolder league = new LeagueFolder(Files.createDirectory(folder.resolve("league " + round)));
                SharedBrokerKey.put(league);
                WorkerAdmission admission = new WorkerAdmission(league,
                    new WorkerPauses(System::currentTimeMillis, league), said -> { });
                List<String> secrets = new ArrayList<>();
                for (int k = 0; k < WORKERS; k++) {
                    secrets.add(added(league, "worker" + k));
                }
                CyclicBarrier together = new CyclicBarrier(WORKERS);
                List<Callable<Boolean>> calls = new ArrayList<>();
                for (int k = 0; k < WORKERS; k++) {
                    String name = "worker" + k;
                    String secret = secrets.get(k);
                    calls.add(() -> {
                        together.await();
                        return admission.admits(name, secret);
                    });
                }
                List<Boolean> admitted = new ArrayList<>();
                for (Future<Boolean> call : threads.invokeAll(calls)) {
                    admitted.add(call.get());
                }
                assertEquals(List.of(true, true, true, true), admitted, "round " + round);
                assertFalse(admission.admits("worker0", secrets.get(1)), "with the secret of another");
            }
        } finally {
            threads.shutdownNow();
        }
    }

    private String added(LeagueFolder league, String name) throws IOException {
        Path token = league.path().resolve(name + ".token");
        WorkerList.add(league, name, token);
        return WorkerToken.read(token).secret();
    }
}
