package steward.machines.serve;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import steward.game.GameSetup;
import steward.league.play.Roster.Member;
import steward.machines.bundle.Bundle;
import steward.machines.bundle.LongScene;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.match.GuestSetup;

/** Bundles that workers may fetch: bots, a long scene, or the files of a guest. Thread-safe. */
final class OfferedBundles {

    private final Map<String, Bundle> byHash = new ConcurrentHashMap<>();
    private final Map<String, Bundle> byStamp = new ConcurrentHashMap<>();
    /** A long scene, or the referee of the scene; {@code null} if there is neither. */
    private volatile Bundle scene;
    private volatile boolean ofReferee;

    /** Returns a bot as jobs name it. */
    GameJob.Seat seat(Member member) {
        Bundle bundle = byStamp.computeIfAbsent(key(member), key -> Bundle.of(member.bot()));
        byHash.put(bundle.hash(), bundle);
        return new GameJob.Seat(member.entrant().name(), bundle.hash(), bundle.bytes().length,
            member.entrant().limits());
    }

    /** Offers the scene if it is a long one, or its referee if it has one. Call once, before workers come. */
    void offerScene(GameSetup setup) {
        ofReferee = setup.isGuest();
        scene = ofReferee ? Bundle.of((GuestSetup) setup) : LongScene.of(setup.scene().json());
        if (scene != null) {
            byHash.put(scene.hash(), scene);
        }
    }

    /** Returns the message with a welcome: a long scene or a referee is named in it, to be fetched. */
    byte[] greeting(LeagueWord.Welcome welcome) {
        return (scene == null ? welcome : welcome.with(ofReferee ? welcome.scene() : null, scene.hash(),
            scene.bytes().length)).bytes();
    }

    private static String key(Member member) {
        return member.bot().name() + "\n" + member.stamp();
    }

    /** Returns the hashes of those bots that were offered. */
    List<String> known(List<Member> members) {
        return members.stream().map(member -> byStamp.get(key(member))).filter(Objects::nonNull).map(Bundle::hash)
            .toList();
    }

    boolean has(String hash) {
        return byHash.containsKey(hash);
    }

    byte[] piece(WorkerWord.Fetch fetch) {
        int from = fetch.from();
        Bundle bundle = byHash.get(fetch.bundle());
        byte[] part = {};
        if (bundle != null && from <= bundle.bytes().length) {
            part = Arrays.copyOfRange(bundle.bytes(), from, Math.min(bundle.bytes().length, from + WireMessage.CHUNK));
        }
        return WireMessage.bytes(new HeaderText().put("type", "bundle").put("bundle", fetch.bundle()).put("from", from)
            .put("known", bundle != null), part);
    }
}
