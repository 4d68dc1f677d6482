package arcomat.cluster.spark;

import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.EngineProvider;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.campaign.engine.WorkerPlan;

import java.util.function.Consumer;

/** Found by the tool as a service. Where things are is Spark's own matter: no meeting is needed. */
public final class SparkProvider implements EngineProvider {
    @Override
    public Engine open(Freight freight, Meeting meeting, Consumer<String> told) {
        return SparkEngine.open(freight, told);
    }

    @Override
    public void work(WorkerPlan plan, Consumer<String> told) {
        throw new EngineFailure("Spark starts its workers itself");
    }
}
