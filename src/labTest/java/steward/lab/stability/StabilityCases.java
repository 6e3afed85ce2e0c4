package steward.lab.stability;

import java.util.List;
import steward.lab.stability.bodies.ColumnsCase;
import steward.lab.stability.bodies.ElasticFallCase;
import steward.lab.stability.bodies.FallenPilesCase;
import steward.lab.stability.bodies.SingleRestCase;
import steward.lab.stability.bodies.SqueezesCase;
import steward.lab.stability.crowds.BulletCase;
import steward.lab.stability.crowds.CrowdCase;
import steward.lab.stability.crowds.DensePackingCase;
import steward.lab.stability.crowds.InelasticCollapseCase;
import steward.lab.stability.crowds.LatticeCase;
import steward.lab.stability.crowds.LongRunCase;
import steward.lab.stability.crowds.MirrorCase;
import steward.lab.stability.crowds.OfficialHeapsCase;
import steward.lab.stability.crowds.PilesCase;
import steward.lab.stability.crowds.RandomCradlesCase;
import steward.lab.stability.crowds.RestCase;
import steward.lab.stability.crowds.SimultaneousCase;
import steward.lab.stability.crowds.TiesCase;
import steward.lab.stability.crowds.TruePathCase;
import steward.lab.stability.pairs.ContactCase;
import steward.lab.stability.pairs.CornerCase;
import steward.lab.stability.pairs.EndOfTurnCase;
import steward.lab.stability.pairs.ExtremeSpeedsCase;
import steward.lab.stability.pairs.GrazingCase;
import steward.lab.stability.pairs.LateTimesCase;
import steward.lab.stability.pairs.MassesCase;
import steward.lab.stability.pairs.NearAndFarCase;
import steward.lab.stability.pairs.OfficialEdgesCase;
import steward.lab.stability.pairs.PiBlocksCase;
import steward.lab.stability.pairs.RandomPairsCase;
import steward.lab.stability.pairs.SlidingCase;
import steward.lab.trial.StabilityCase;

/** List of all cases of the stability table, in order; no other place lists them. */
public final class StabilityCases {

    private StabilityCases() { }

    public static List<StabilityCase> all() {
        return List.of(
            new PiBlocksCase(),
            new GrazingCase(),
            new NearAndFarCase(),
            new ContactCase(),
            new MassesCase(),
            new ExtremeSpeedsCase(),
            new BulletCase(),
            new LateTimesCase(),
            new EndOfTurnCase(),
            new CornerCase(),
            new SlidingCase(),
            new RandomCradlesCase(),
            new MirrorCase(),
            new RestCase(),
            new PilesCase(),
            new SqueezesCase(),
            new SingleRestCase(),
            new ElasticFallCase(),
            new ColumnsCase(),
            new FallenPilesCase(),
            new InelasticCollapseCase(),
            new LatticeCase(),
            new TiesCase(),
            new SimultaneousCase(),
            new OfficialHeapsCase(),
            new OfficialEdgesCase(),
            new DensePackingCase(),
            new LongRunCase(10, 5e-14),
            new LongRunCase(100, 1e-14),
            new LongRunCase(1000, 1e-15),
            new CrowdCase(100, 0.1, 100_000_000),
            new CrowdCase(1000, 0.1, 1_000_000_000),
            new CrowdCase(10_000, 0.1, 100_000_000),
            new CrowdCase(1000, 0.8, 100_000_000),
            new TruePathCase(),
            new RandomPairsCase(200),
            new RandomPairsCase(900));
    }
}
