package arcomat.cluster.hazelcast;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.cluster.hazelcast.Letter.Answer;
import arcomat.cluster.hazelcast.Letter.Answers;
import arcomat.cluster.hazelcast.Letter.Breakdown;
import arcomat.cluster.hazelcast.Letter.Hello;
import arcomat.cluster.hazelcast.Letter.Refusal;
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
import java.util.UUID;

/**
 * Letters and trials as bytes of a form of their own: nothing that travels can name a class. What
 * is read is believed in nothing: it may come from anybody.
 */
final class LetterText {
    private static final byte HELLO = 1;
    private static final byte ANSWERS = 2;
    private static final byte REFUSAL = 3;
    private static final byte BREAKDOWN = 4;

    /** Letters of a text that is shown to people; the form of Java's has room for 21,845. */
    private static final int LONGEST = 4000;

    private LetterText() {}

    private interface Writing {
        void to(DataOutputStream out) throws IOException;
    }

    private static byte[] bytes(Writing writing) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            writing.to(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    static byte[] of(Letter letter) {
        return letter.match(
                hello ->
                        bytes(
                                out -> {
                                    out.writeByte(HELLO);
                                    write(hello.worker(), out);
                                    out.writeInt(hello.threads());
                                    out.writeLong(hello.process());
                                }),
                answers -> bytes(out -> write(answers, out)),
                refusal ->
                        bytes(
                                out -> {
                                    out.writeByte(REFUSAL);
                                    write(refusal.version(), out);
                                }),
                breakdown ->
                        bytes(
                                out -> {
                                    out.writeByte(BREAKDOWN);
                                    write(breakdown.worker(), out);
                                    write(breakdown.why(), out);
                                }));
    }

    private static void write(UUID worker, DataOutputStream out) throws IOException {
        out.writeLong(worker.getMostSignificantBits());
        out.writeLong(worker.getLeastSignificantBits());
    }

    private static void write(String text, DataOutputStream out) throws IOException {
        out.writeUTF(text.length() > LONGEST ? text.substring(0, LONGEST) : text);
    }

    private static void write(Answers answers, DataOutputStream out) throws IOException {
        out.writeByte(ANSWERS);
        write(answers.worker(), out);
        out.writeInt(answers.rows().size());
        for (Answer each : answers.rows()) {
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
     * @throws IOException where these are not the bytes of a letter
     */
    static Letter letter(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        byte kind = in.readByte();
        return switch (kind) {
            case HELLO -> hello(in);
            case ANSWERS -> new Answers(worker(in), answers(in));
            case REFUSAL -> new Refusal(in.readUTF());
            case BREAKDOWN -> new Breakdown(worker(in), in.readUTF());
            default -> throw new IOException("a letter of kind " + kind);
        };
    }

    private static Hello hello(DataInputStream in) throws IOException {
        Hello hello = new Hello(worker(in), in.readInt(), in.readLong());
        if (hello.threads() < 1) {
            throw new IOException("a worker of " + hello.threads() + " threads");
        }
        return hello;
    }

    private static UUID worker(DataInputStream in) throws IOException {
        return new UUID(in.readLong(), in.readLong());
    }

    private static List<Answer> answers(DataInputStream in) throws IOException {
        int size = in.readInt();
        List<Answer> rows = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            rows.add(
                    new Answer(
                            in.readLong(),
                            ending(in.readByte()),
                            in.readUTF(),
                            numbers(in),
                            reached(in)));
        }
        return rows;
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
        byte[] text = in.readNBytes(Math.max(0, in.readInt()));
        try {
            return new ReachedItems(new String(text, StandardCharsets.US_ASCII));
        } catch (IllegalArgumentException e) {
            throw new IOException(e);
        }
    }

    static byte[] of(List<Trial> trials) {
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
    static List<Trial> trials(byte[] bytes) throws IOException {
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
