package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.ReachedItems;

import java.util.List;

/**
 * A row without its trial, which whoever asked knows.
 *
 * @param number of the trial
 * @param remark why there are no answers; empty where the run was made
 * @param reached what the run has covered
 */
public record Answer(
        long number, Row.Ending ending, String remark, List<Double> answers, ReachedItems reached) {
    public Answer {
        answers = List.copyOf(answers);
    }

    public static Answer of(Row row) {
        return new Answer(
                row.trial().number(), row.ending(), row.remark(), row.answers(), row.reached());
    }

    /**
     * @param trial the one of this number
     */
    public Row row(Trial trial) {
        return new Row(trial, ending, remark, answers, reached);
    }
}
