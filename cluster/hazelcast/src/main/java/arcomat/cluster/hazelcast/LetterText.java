package arcomat.cluster.hazelcast;

import arcomat.cluster.hazelcast.Letter.Answers;
import arcomat.cluster.hazelcast.Letter.Breakdown;
import arcomat.cluster.hazelcast.Letter.Hello;
import arcomat.cluster.hazelcast.Letter.Refusal;
import arcomat.pipeline.campaign.engine.TrialBytes;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.UUID;

/**
 * Letters as bytes, with the answers in them as {@link TrialBytes} has them. What is read is
 * believed in nothing: it may come from anybody.
 */
final class LetterText {
    private static final byte HELLO = 1;
    private static final byte ANSWERS = 2;
    private static final byte REFUSAL = 3;
    private static final byte BREAKDOWN = 4;

    private LetterText() {}

    static byte[] of(Letter letter) {
        return letter.match(
                hello ->
                        TrialBytes.bytes(
                                out -> {
                                    out.writeByte(HELLO);
                                    write(hello.worker(), out);
                                    out.writeInt(hello.threads());
                                    out.writeLong(hello.process());
                                }),
                answers -> TrialBytes.bytes(out -> write(answers, out)),
                refusal ->
                        TrialBytes.bytes(
                                out -> {
                                    out.writeByte(REFUSAL);
                                    TrialBytes.write(refusal.version(), out);
                                }),
                breakdown ->
                        TrialBytes.bytes(
                                out -> {
                                    out.writeByte(BREAKDOWN);
                                    write(breakdown.worker(), out);
                                    TrialBytes.write(breakdown.why(), out);
                                }));
    }

    private static void write(UUID worker, DataOutputStream out) throws IOException {
        out.writeLong(worker.getMostSignificantBits());
        out.writeLong(worker.getLeastSignificantBits());
    }

    private static void write(Answers answers, DataOutputStream out) throws IOException {
        out.writeByte(ANSWERS);
        write(answers.worker(), out);
        TrialBytes.write(answers.rows(), out);
    }

    /**
     * @throws IOException where these are not the bytes of a letter
     */
    static Letter letter(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        byte kind = in.readByte();
        return switch (kind) {
            case HELLO -> hello(in);
            case ANSWERS -> new Answers(worker(in), TrialBytes.answers(in));
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
}
