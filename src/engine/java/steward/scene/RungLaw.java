package steward.scene;

import java.util.Arrays;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.physics.ImpactLaw;

/**
 * The law of impact of one rung, with its version. Whoever changes bits of a rung on purpose gives its law the next
 * version and the fingerprint that {@code RungLawTest} prints: then seasons, calibrations and replays of that law end,
 * and those of other laws stay.
 */
public enum RungLaw {

    /** Fixed steps, however many. */
    STEP(1, "47c4e2ffb64cd9a1"),
    /** {@code event/official}, where bodies cannot come to rest. */
    OFFICIAL(1, "503e94a136d51a78"),
    /** {@code event/official}, where they can. */
    OFFICIAL_WITH_REST(5, "5a1bd5480009a639"),
    /** {@code event/double}, where bodies cannot come to rest. */
    DOUBLE(1, "f465cab171fe3b9e"),
    /** {@code event/double}, where they can. */
    DOUBLE_WITH_REST(5, "58ac114499015aa9"),
    /** {@code event/compensated}, where bodies cannot come to rest. */
    COMPENSATED(2, "40397a35ed557add"),
    /** {@code event/compensated}, where they can. */
    COMPENSATED_WITH_REST(6, "6af087f4f0f5c961"),
    /** {@code event/exact}, where bodies cannot come to rest. */
    EXACT(2, "645d2e6a31ecc31a"),
    /** {@code event/exact}, where they can. */
    EXACT_WITH_REST(6, "6096fea5fb656cd1"),
    /** {@code event/official}, where forces act on bodies that cannot come to rest. */
    OFFICIAL_WITH_FORCES(2, "8b898bf768825e1a"),
    /** {@code event/double}, where forces act on bodies that cannot come to rest. */
    DOUBLE_WITH_FORCES(2, "b6b4db6a1843fb98"),
    /** {@code event/compensated}, where forces act on bodies that cannot come to rest. */
    COMPENSATED_WITH_FORCES(3, "428ec50add56e78c"),
    /** {@code event/exact}, where forces act on bodies that cannot come to rest. */
    EXACT_WITH_FORCES(3, "8de4a6c29935e9d3");

    /** The fingerprint of the whole ladder that programs had before laws had versions: law 1 of every rung. */
    public static final String WHOLE_LADDER = "b8309ca632eecf63";

    private final int version;
    private final String fingerprint;

    /** @param fingerprint of the bits that this version computes, as {@link PhysicsFingerprint} finds it */
    RungLaw(int version, String fingerprint) {
        this.version = version;
        this.fingerprint = fingerprint;
    }

    /**
     * The law by which bodies under an impact law are advanced on a rung.
     *
     * @param forces whether forces act on them; laws with batches do not ask
     */
    public static RungLaw of(Accuracy rung, ImpactLaw law, boolean forces) {
        return of(rung, law.bodiesRest(), forces && !law.separatingPairsReact());
    }

    private static RungLaw of(Accuracy rung, boolean rest, boolean forces) {
        return switch (rung.way()) {
            case STEP -> STEP;
            case EVENT -> switch (rung.arithmetic()) {
                case OFFICIAL -> rest ? OFFICIAL_WITH_REST : forces ? OFFICIAL_WITH_FORCES : OFFICIAL;
                case DOUBLE -> rest ? DOUBLE_WITH_REST : forces ? DOUBLE_WITH_FORCES : DOUBLE;
                case COMPENSATED -> rest ? COMPENSATED_WITH_REST : forces ? COMPENSATED_WITH_FORCES : COMPENSATED;
                case EXACT -> rest ? EXACT_WITH_REST : forces ? EXACT_WITH_FORCES : EXACT;
            };
        };
    }

    /** 1 for the law that the rung had when versions began; a replay's header names later ones. */
    public int version() {
        return version;
    }

    /** The fingerprint that this version is known by; this program computes {@link PhysicsFingerprint#of}. */
    public String fingerprint() {
        return fingerprint;
    }

    /**
     * The name of what this program computes by this law. Law 1 has one name on all rungs, the one that seasons and
     * parts of leagues of earlier programs carry; anything else is named by its fingerprint.
     *
     * @return 16 hexadecimal digits
     */
    public String key() {
        String computed = PhysicsFingerprint.of(this);
        return isFirst(computed) ? WHOLE_LADDER : computed;
    }

    private boolean isFirst(String computed) {
        return version == 1 && computed.equals(fingerprint);
    }

    /** The keys of all laws, in their order: what a worker says of itself. */
    public static String keys() {
        return Arrays.stream(values()).map(RungLaw::key).collect(Collectors.joining(" "));
    }

    /** The key of this law among {@link #keys} of another program; a program without versions has one for all. */
    public String keyAmong(String keys) {
        String[] each = keys.split(" ");
        return each.length == 1 ? each[0] : ordinal() < each.length ? each[ordinal()] : "";
    }

    /**
     * True if figures of a rung still hold.
     *
     * @param measured the fingerprint of the law that was measured; {@link #WHOLE_LADDER} is that of law 1
     * @param mayRest  whether bodies of the scene may come to rest: then figures of the whole ladder hold only if both
     *                 laws of the rung are the first, since they do not say which of them was measured
     * @param computed gives the fingerprint of what this program computes by a law
     */
    static boolean holds(String measured, Accuracy rung, boolean mayRest, Function<RungLaw, String> computed) {
        Stream<RungLaw> laws = Stream.of(of(rung, false, false), of(rung, true, false), of(rung, false, true));
        return measured.equals(WHOLE_LADDER)
            ? laws.limit(mayRest ? 3 : 1).allMatch(law -> law.isFirst(computed.apply(law)))
            : laws.map(computed).anyMatch(measured::equals);
    }
}
