package arcomat.pipeline.campaign.engine;

/**
 * What a worker is to do.
 *
 * @param meeting where it finds campaigns
 * @param threads how many runs it makes at a time
 * @param version of the tool that it is: it makes no runs for another one
 * @param once whether it ends with the first campaign, a few seconds after it
 */
public record WorkerPlan(Meeting meeting, int threads, String version, boolean once) {}
