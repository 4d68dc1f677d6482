package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Campaign;
import arcomat.campaign.Quantity;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.world.Approach;
import arcomat.world.Physics;
import arcomat.world.Scene;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** When a run reaches the levels of a splitting. */
final class LevelTimes implements Onlooker {
    private static final double STEPS_PER_SECOND = 1000.0 / Physics.STEP;

    private final Onlooker first;
    private final @Nullable Approach approach;

    /**
     * @param split empty where there are no levels
     * @param first sees every scene before
     */
    LevelTimes(Optional<Campaign.Split> split, World world, Onlooker first) {
        this.first = first;
        this.approach =
                split.map(each -> new Approach(world, to(each), each.levels())).orElse(null);
    }

    private static Approach.To to(Campaign.Split split) {
        boolean robots = split.measure().equals(Quantity.DISTANCE.word());
        return robots ? Approach.To.ROBOTS : Approach.To.REST;
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        first.see(scene, instruments);
        if (approach != null) {
            approach.see(scene);
        }
    }

    /** In seconds, one for each level; infinite where it was not reached. */
    List<Double> answers() {
        return approach == null
                ? List.of()
                : approach.ticks().stream().map(LevelTimes::seconds).toList();
    }

    private static double seconds(OptionalLong tick) {
        return tick.isPresent() ? tick.getAsLong() / STEPS_PER_SECOND : Double.POSITIVE_INFINITY;
    }
}
