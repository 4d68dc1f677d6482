package arcomat.cluster.spark;

import arcomat.campaign.Trial;
import arcomat.pipeline.campaign.engine.Answer;
import arcomat.pipeline.campaign.engine.TrialBytes;
import arcomat.pipeline.campaign.engine.TrialRunner;

import org.apache.spark.TaskContext;
import org.apache.spark.TaskKilledException;
import org.apache.spark.broadcast.Broadcast;

import scala.collection.Iterator;
import scala.runtime.AbstractFunction1;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;

/**
 * What a task does: makes the runs of a batch. A fault of ours is an answer, too: Spark would try
 * the batch again elsewhere, to meet the same fault.
 */
final class MakeRuns extends AbstractFunction1<Iterator<byte[]>, byte[]> implements Serializable {
    private static final long serialVersionUID = 1L;

    private final Broadcast<Workshop> workshop;

    MakeRuns(Broadcast<Workshop> workshop) {
        this.workshop = workshop;
    }

    @Override
    public byte[] apply(Iterator<byte[]> partition) {
        try {
            return make(TrialBytes.trials(partition.next()), workshop.value().runner()).bytes();
        } catch (TaskKilledException stopped) {
            throw stopped;
        } catch (IOException | RuntimeException | Error e) {
            return TaskAnswer.failed(e).bytes();
        }
    }

    private static TaskAnswer make(List<Trial> trials, TrialRunner runner) {
        long begun = System.nanoTime();
        List<Answer> answers = new ArrayList<>();
        for (Trial each : trials) {
            if (TaskContext.get().isInterrupted()) { // nobody wants the rest
                throw new TaskKilledException("the campaign is decided");
            }
            answers.add(Answer.of(runner.apply(each)));
        }
        return TaskAnswer.made(answers, System.nanoTime() - begun);
    }
}
