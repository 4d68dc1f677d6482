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
    private String said = "";

    @Override
    public Engine open(Freight freight, Meeting meeting, Consumer<String> told) {
        return SparkEngine.open(freight, line -> say(line, told));
    }

    /** A search that follows the table has the same Spark, which is not said again. */
    private void say(String line, Consumer<String> told) {
        if (!line.equals(said)) {
            told.accept(line);
            said = line;
        }
    }

    @Override
    public void work(WorkerPlan plan, Consumer<String> told) {
        throw new EngineFailure("Spark starts its workers itself");
    }
}
