package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.world.Seeds;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Trials and their answers as bytes of a form of their own, as they go from process to process:
 * nothing that travels can name a class. What is read is believed in nothing: it may come from
 * anybody.
 */
public final class TrialBytes {
    /** Characters of a text that is shown to people; the form of Java's has room for 21,845. */
    private static final int LONGEST = 4000;

    private TrialBytes() {}

    /** Something that is put into bytes, piece by piece. */
    public interface Writing {
        void to(DataOutputStream out) throws IOException;
    }

    /** What was written. */
    public static byte[] bytes(Writing writing) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            writing.to(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** A text for people: one that is too long is cut. */
    public static void write(String text, DataOutputStream out) throws IOException {
        out.writeUTF(text.length() > LONGEST ? text.substring(0, LONGEST) : text);
    }

    public static void write(List<Answer> answers, DataOutputStream out) throws IOException {
        out.writeInt(answers.size());
        for (Answer each : answers) {
            out.writeLong(each.number());
            out.writeByte(each.ending().ordinal());
            write(each.remark(), out);
            out.writeInt(each.answers().size());
            for (double answer : each.answers()) {
                out.writeDouble(answer);
            }
            byte[] reached = each.reached().text().getBytes(StandardCharsets.US_ASCII);
            out.writeInt(reached.length);
            out.write(reached);
        }
    }

    /**
     * @throws IOException where these are not the bytes of answers
     */
    public static List<Answer> answers(DataInputStream in) throws IOException {
        int size = in.readInt();
        List<Answer> answers = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            long number = in.readLong();
            answers.add(
                    new Answer(
                            number, ending(in.readByte()), in.readUTF(), numbers(in), reached(in)));
        }
        return answers;
    }

    private static Row.Ending ending(byte ordinal) throws IOException {
        Row.Ending[] all = Row.Ending.values();
        if (ordinal < 0 || ordinal >= all.length) {
            throw new IOException("ending " + ordinal);
        }
        return all[ordinal];
    }

    private static List<Double> numbers(DataInputStream in) throws IOException {
        int size = in.readInt();
        List<Double> numbers = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            numbers.add(in.readDouble());
        }
        return numbers;
    }

    /** As long as models are large: the form of Java's texts has no room for all of them. */
    private static ReachedItems reached(DataInputStream in) throws IOException {
        int length = in.readInt();
        byte[] text = in.readNBytes(Math.max(0, length));
        try {
            if (text.length == length) {
                return new ReachedItems(new String(text, StandardCharsets.US_ASCII));
            }
        } catch (IllegalArgumentException e) {
            throw new IOException(e);
        }
        throw new IOException("items of " + length + " characters");
    }

    public static byte[] of(List<Trial> trials) {
        return bytes(
                out -> {
                    out.writeInt(trials.size());
                    for (Trial each : trials) {
                        write(each, out);
                    }
                });
    }

    private static void write(Trial trial, DataOutputStream out) throws IOException {
        out.writeLong(trial.number());
        out.writeUTF(trial.seeds().text());
        out.writeInt(trial.values().size());
        for (Map.Entry<String, String> each : trial.values().entrySet()) {
            out.writeUTF(each.getKey());
            out.writeUTF(each.getValue());
        }
    }

    /**
     * @throws IOException where these are not the bytes of trials
     */
    public static List<Trial> trials(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        int size = in.readInt();
        List<Trial> trials = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            trials.add(trial(in));
        }
        return trials;
    }

    private static Trial trial(DataInputStream in) throws IOException {
        long number = in.readLong();
        Seeds seeds = seeds(in.readUTF());
        int size = in.readInt();
        Map<String, String> values = new LinkedHashMap<>();
        for (int i = 0; i < size; i++) {
            values.put(in.readUTF(), in.readUTF());
        }
        return new Trial(number, seeds, values);
    }

    private static Seeds seeds(String text) throws IOException {
        try {
            return Seeds.parse(text);
        } catch (IllegalArgumentException e) {
            throw new IOException(e);
        }
    }
}
