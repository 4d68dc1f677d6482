package arcomat.cluster.hazelcast;

import arcomat.pipeline.campaign.engine.Answer;

import java.util.List;
import java.util.UUID;
import java.util.function.Function;

/** What a worker writes to the campaign; {@link LetterText} has it as bytes. */
sealed interface Letter {
    /** Takes the sum apart: one answer for each form. */
    <R> R match(
            Function<Hello, R> hello,
            Function<Answers, R> answers,
            Function<Refusal, R> refusal,
            Function<Breakdown, R> breakdown);

    /**
     * It is ready for work.
     *
     * @param process its number on its machine
     */
    record Hello(UUID worker, int threads, long process) implements Letter {
        @Override
        public <R> R match(
                Function<Hello, R> hello,
                Function<Answers, R> answers,
                Function<Refusal, R> refusal,
                Function<Breakdown, R> breakdown) {
            return hello.apply(this);
        }
    }

    /** Rows of runs that it has made. */
    record Answers(UUID worker, List<Answer> rows) implements Letter {
        @Override
        public <R> R match(
                Function<Hello, R> hello,
                Function<Answers, R> answers,
                Function<Refusal, R> refusal,
                Function<Breakdown, R> breakdown) {
            return answers.apply(this);
        }
    }

    /** It is of another version and makes no runs for this one. */
    record Refusal(String version) implements Letter {
        @Override
        public <R> R match(
                Function<Hello, R> hello,
                Function<Answers, R> answers,
                Function<Refusal, R> refusal,
                Function<Breakdown, R> breakdown) {
            return refusal.apply(this);
        }
    }

    /** A fault of ours keeps it from making runs. */
    record Breakdown(UUID worker, String why) implements Letter {
        @Override
        public <R> R match(
                Function<Hello, R> hello,
                Function<Answers, R> answers,
                Function<Refusal, R> refusal,
                Function<Breakdown, R> breakdown) {
            return breakdown.apply(this);
        }
    }
}
