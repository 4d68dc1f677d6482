package arcomat.pipeline.campaign.engine;

import java.util.function.Consumer;

/** A way to make runs in several processes; found as a service, with its libraries. */
public interface EngineProvider {
    /**
     * An engine whose runs are made by workers, which may come and go as they like.
     *
     * @param freight what they are sent
     * @param told is told, in lines for people, who comes and goes
     * @throws EngineFailure where nobody can listen at the meeting's address
     */
    Engine open(Freight freight, Meeting meeting, Consumer<String> told);

    /**
     * Makes runs for the campaigns that come to the meeting, one after the other, until the thread
     * is interrupted.
     *
     * @param told is told, in lines for people, what it is doing
     * @throws EngineFailure where it can make no runs, as for a campaign of another version
     */
    void work(WorkerPlan plan, Consumer<String> told);
}
