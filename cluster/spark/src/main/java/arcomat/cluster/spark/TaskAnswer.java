package arcomat.cluster.spark;

import arcomat.pipeline.campaign.engine.Answer;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.TrialBytes;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.util.List;

/**
 * What a task sends back.
 *
 * @param why what kept it from making runs; empty where it has made them
 * @param nanoseconds what all its runs took together
 */
record TaskAnswer(String why, long nanoseconds, List<Answer> answers) {
    static TaskAnswer made(List<Answer> answers, long nanoseconds) {
        return new TaskAnswer("", nanoseconds, answers);
    }

    static TaskAnswer failed(Throwable fault) {
        String why =
                fault instanceof EngineFailure failure
                        ? String.valueOf(failure.getMessage())
                        : "a run could not be made, this is a fault of arcomat: " + fault;
        return new TaskAnswer(why, 0, List.of());
    }

    byte[] bytes() {
        return TrialBytes.bytes(
                out -> {
                    TrialBytes.write(why, out);
                    out.writeLong(nanoseconds);
                    TrialBytes.write(answers, out);
                });
    }

    /**
     * @throws IOException where these are not the bytes of an answer
     */
    static TaskAnswer of(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        return new TaskAnswer(in.readUTF(), in.readLong(), TrialBytes.answers(in));
    }
}
