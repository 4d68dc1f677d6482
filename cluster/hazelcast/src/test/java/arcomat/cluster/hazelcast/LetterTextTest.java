package arcomat.cluster.hazelcast;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Row;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.pipeline.campaign.engine.Answer;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import java.util.stream.Stream;

class LetterTextTest {
    private static final UUID WORKER = new UUID(1, -2);

    static Stream<Letter> letters() {
        List<Double> numbers = List.of(0.1, Double.NaN, -0.0, Double.MAX_VALUE, 1e-300);
        return Stream.of(
                new Letter.Hello(WORKER, 4, 123_456),
                new Letter.Answers(WORKER, List.of()),
                new Letter.Answers(
                        WORKER,
                        List.of(
                                new Answer(
                                        7,
                                        Row.Ending.MADE,
                                        "",
                                        numbers,
                                        new ReachedItems("x" + "0f".repeat(50_000))),
                                new Answer(
                                        8,
                                        Row.Ending.IMPOSSIBLE,
                                        "Straße, \"x\"",
                                        List.of(),
                                        ReachedItems.UNKNOWN))),
                new Letter.Refusal("0.2.0"),
                new Letter.Breakdown(WORKER, "java.lang.OutOfMemoryError"));
    }

    @Tag("some-slow")
    @ParameterizedTest
    @MethodSource("letters")
    void whatIsWrittenIsRead(Letter letter) throws IOException {
        assertThat(LetterText.letter(LetterText.of(letter))).isEqualTo(letter);
    }

    /** It may come from anybody: nothing but this exception, and no memory that is not there. */
    @Tag("some-slow")
    @ParameterizedTest
    @MethodSource("letters")
    void whatIsDamagedIsNoLetter(Letter letter) {
        byte[] whole = LetterText.of(letter);
        // Of a long one the same is in its middle everywhere.
        int step = Math.max(1, whole.length / 500);
        for (int i = 0; i < whole.length; i += i < 200 ? 1 : step) {
            byte[] cut = Arrays.copyOf(whole, i);
            assertThat(read(cut)).as("%d bytes", i).isFalse();
            for (int value : new int[] {0, 1, 127, 128, 255}) {
                byte[] damaged = whole.clone();
                damaged[i] = (byte) value;
                read(damaged);
            }
        }
    }

    private static boolean read(byte[] bytes) {
        try {
            LetterText.letter(bytes);
            return true;
        } catch (IOException refused) {
            return false;
        }
    }
}
