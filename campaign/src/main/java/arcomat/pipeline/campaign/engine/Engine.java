package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;

import java.time.Duration;
import java.util.List;

/**
 * Makes the runs of one campaign. Used by one thread. Each trial that was submitted gives exactly
 * one row, in any order, whatever is lost on the way; rows of other campaigns never appear.
 */
public interface Engine extends AutoCloseable {
    /** How many trials can be made at a time, now; at least 1. */
    int capacity();

    /** Takes trials; returns at once. */
    void submit(List<Trial> batch);

    /**
     * The rows that have been made since it was last asked.
     *
     * @param patience how long to wait for the first, if there is none yet
     * @return none if nothing came in that time
     * @throws EngineFailure where runs cannot go on
     */
    List<Row> collect(Duration patience);

    /** Who works for it, in a few words for people: {@code 2 threads}. */
    String crew();

    /** Nothing more is wanted; trials that are not made yet are forgotten. */
    @Override
    void close();
}
