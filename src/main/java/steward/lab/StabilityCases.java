package steward.lab;

import java.util.List;

/** The rows of the stability table, in its order: the one place that lists them. */
public final class StabilityCases {

    private StabilityCases() {
    }

    /** All cases. */
    public static List<StabilityCase> all() {
        return List.of(
            new PiBlocksCase(),
            new GrazingCase(),
            new NearAndFarCase(),
            new ContactCase(),
            new MassesCase(),
            new ExtremeSpeedsCase(),
            new BulletCase(),
            new RadiusRatioCase(),
            new LateTimesCase(),
            new CornerCase(),
            new CradleCase(),
            new MirrorCase(),
            new CollapseCase(),
            new LatticeCase(),
            new OfficialHeapsCase(),
            new OfficialEdgesCase(),
            new DensePackingCase(),
            new TimeReversalCase(),
            new LongRunCase(10, 5e-14),
            new LongRunCase(100, 1e-14),
            new LongRunCase(1000, 1e-15),
            new RoundingCase(),
            new RandomPairsCase(200),
            new RandomPairsCase(900));
    }
}
