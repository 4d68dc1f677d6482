package arcomat.cluster.spark;

import arcomat.cli.terminal.Version;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.Serializable;

/**
 * Where a process makes runs of a campaign. Spark broadcasts it: each executor has one, which its
 * tasks share, so that a campaign is prepared once per process. What is prepared does not travel.
 */
final class Workshop implements Serializable {
    private static final long serialVersionUID = 1L;

    private final byte[] freight;
    private transient @Nullable TrialRunner runner;

    Workshop(Freight freight) {
        this.freight = freight.packed();
    }

    /**
     * Asked by all tasks of a process at once: one prepares, the others wait.
     *
     * @throws EngineFailure where this process has another version of the tool
     */
    synchronized TrialRunner runner() throws IOException {
        if (runner == null) {
            Freight unpacked = Freight.unpacked(freight);
            requireSameVersion(unpacked.version(), Version.number());
            runner = new TrialRunner(unpacked);
        }
        return runner;
    }

    /**
     * {@code spark-submit} gives all processes one jar, but a cluster may have another one among
     * Spark's own, and that one comes first.
     */
    static void requireSameVersion(String campaign, String here) {
        if (!campaign.equals(here)) {
            throw new EngineFailure(
                    "an executor has version "
                            + here
                            + " of arcomat, and the campaign is made by version "
                            + campaign
                            + ": look for another jar of it among Spark's");
        }
    }
}
