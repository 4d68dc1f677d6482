package arcomat.cluster.hazelcast;

import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineProvider;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.campaign.engine.WorkerPlan;

import java.util.function.Consumer;

/** Found by the tool as a service. */
public final class HazelcastProvider implements EngineProvider {
    @Override
    public Engine open(Freight freight, Meeting meeting, Consumer<String> told) {
        return HazelcastEngine.open(freight, meeting, told);
    }

    @Override
    public void work(WorkerPlan plan, Consumer<String> told) {
        new HazelcastWorker(plan, told).work();
    }
}
