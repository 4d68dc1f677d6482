package arcomat.live.robot;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Processor;
import arcomat.sim.radio.Channel;
import arcomat.sim.radio.Link;
import arcomat.sim.time.VirtualTime;

import org.jspecify.annotations.Nullable;

import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * The connection to another brick, with a thread of its own that calls or waits to be called, and
 * then looks for messages. A packet is one message: its channel and its four bytes, the highest
 * first.
 */
final class Telephone {
    private static final int CHANNELS = 8;
    private static final int PACKET = 5;

    /** Milliseconds: to wait for a call, between calls, between looks for messages. */
    private static final int LISTENING = 10_000;

    private static final int PAUSE = 1000;
    private static final int REST = 10;

    /** Milliseconds that a brick calls before it gives up, and that a connection takes. */
    private static final int DIALLING = 5000;

    private static final int HANDSHAKE = 500;

    private static final int END = -1;

    private final Hardware brick;
    private final String peer;
    private final Routine routine;
    private final Mailbox[] incoming = boxes();

    /** Null where nobody sends. */
    private final @Nullable Mailbox[] outgoing = new @Nullable Mailbox[CHANNELS];

    private final byte[] packet = new byte[PACKET];

    /**
     * @param peer name of the other brick; empty for the one that calls this one
     */
    Telephone(Hardware brick, String peer) {
        this.brick = brick;
        this.peer = peer;
        this.routine = new Routine(brick.time());
    }

    private static Mailbox[] boxes() {
        return IntStream.range(0, CHANNELS).mapToObj(i -> new Mailbox()).toArray(Mailbox[]::new);
    }

    Mailbox incoming(int channel) {
        return incoming[channel];
    }

    Mailbox outgoing(int channel) {
        Mailbox box = outgoing[channel];
        if (box == null) {
            box = new Mailbox();
            outgoing[channel] = box;
        }
        return box;
    }

    void start() {
        routine.start(this::connect);
    }

    private void connect() {
        if (peer.isEmpty()) {
            brick.radio().listen(routine::wake);
            awaitCall(brick.tickAfter(LISTENING));
        } else {
            routine.call(this::call);
        }
    }

    private void awaitCall(long end) {
        if (!brick.radio().isCalled() && brick.time().now() < end) {
            routine.until(() -> end, () -> awaitCall(end));
        } else {
            brick.radio().stopListening();
            Optional<Link> made = brick.radio().accepted();
            routine.until(() -> brick.tickAfter(1), () -> connected(made));
        }
    }

    private void call() {
        if (brick.radio().knows(peer)) {
            dial(brick.milliseconds() + DIALLING);
        } else {
            connected(Optional.empty());
        }
    }

    private void dial(long end) {
        Optional<Link> made = brick.radio().connect(peer);
        if (made.isEmpty() && brick.milliseconds() < end) {
            routine.until(() -> brick.tickAfter(1), () -> dial(end));
        } else {
            routine.until(
                    () -> brick.time().now() + HANDSHAKE * VirtualTime.MILLISECOND,
                    () -> connected(made));
        }
    }

    private void connected(Optional<Link> made) {
        if (made.isEmpty()) {
            routine.until(() -> brick.tickAfter(PAUSE), routine::loop);
            routine.then(this::connect);
        } else {
            exchange(made.get());
        }
    }

    /** Takes what has arrived, sends what waits, and looks again a little later. */
    private void exchange(Link link) {
        routine.call(() -> receive(link));
        // Reads nothing, but says whether the connection stands.
        routine.then(() -> read(link.incoming(), 0, false, end -> goOn(link, end == 0)));
    }

    private void goOn(Link link, boolean stands) {
        if (!stands) {
            close(link);
            return;
        }
        long idle = Processor.ROUND;
        for (int i = 0; i < CHANNELS; i++) {
            Mailbox box = outgoing[i];
            if (box != null) {
                int channel = i;
                routine.idle(idle);
                routine.call(() -> send(link, channel, box));
                idle = Processor.ROUND;
            } else {
                idle += 2 * Processor.CALL + 2 * Processor.ROUND;
            }
        }
        routine.idle(idle + Processor.ROUND);
        routine.then(() -> routine.until(() -> brick.tickAfter(REST), () -> exchange(link)));
    }

    private void close(Link link) {
        routine.drop();
        routine.call(link::close);
        routine.loop();
        routine.then(this::connect);
    }

    private void receive(Link link) {
        Channel channel = link.incoming();
        int length = channel.length(brick.time().now());
        routine.loop();
        if (length > 0) {
            routine.then(() -> read(channel, PACKET, true, taken -> arrived(link, length, taken)));
        }
    }

    private void arrived(Link link, int length, int taken) {
        // A packet of another program is no message.
        if (length == PACKET && taken == PACKET && packet[0] >= 0 && packet[0] < CHANNELS) {
            int channel = packet[0];
            int message = message();
            routine.call();
            loopOverBytes();
            routine.call(() -> incoming[channel].put(message));
        }
        if (taken < 0) {
            close(link);
        } else {
            routine.then(() -> skip(link, length - taken));
        }
    }

    /** Leaves out the rest of a packet that is too long. */
    private void skip(Link link, int rest) {
        routine.loop();
        if (rest == 0) {
            routine.call(() -> receive(link));
        } else {
            routine.then(
                    () ->
                            read(
                                    link.incoming(),
                                    Math.min(rest, PACKET),
                                    true,
                                    taken -> skipped(link, rest, taken)));
        }
    }

    private void skipped(Link link, int rest, int taken) {
        if (taken <= 0) {
            close(link);
        } else {
            skip(link, rest - taken);
        }
    }

    /** What is taken: a number of bytes, 0 for none yet, or the end. */
    private void read(Channel channel, int length, boolean waits, IntConsumer taken) {
        routine.call(
                () -> {
                    long now = brick.time().now();
                    int wanted = waits ? Math.min(length, channel.left(now)) : Math.min(length, 1);
                    if (wanted > 0 && channel.arrived(now) >= wanted) {
                        taken.accept(take(channel, length, now));
                    } else if (channel.isFinished()) {
                        taken.accept(END);
                    } else if (!waits || length == 0) {
                        taken.accept(0);
                    } else {
                        routine.until(
                                () -> brick.tickAfter(1), () -> read(channel, length, true, taken));
                    }
                });
    }

    private int take(Channel channel, int length, long now) {
        int taken = Math.min(length, channel.arrived(now));
        channel.take(packet, taken);
        brick.observer().packetReceived(now, packet, taken);
        return taken;
    }

    private int message() {
        int message = 0;
        for (int i = 1; i < PACKET; i++) {
            message = message << Byte.SIZE | packet[i] & 0xff;
        }
        return message;
    }

    private void send(Link link, int channel, Mailbox box) {
        routine.call(
                () -> {
                    routine.loop();
                    if (!box.isEmpty()) {
                        routine.call(() -> pack(channel, box.take()));
                        loopOverBytes();
                        routine.then(() -> write(link, () -> send(link, channel, box)));
                    }
                });
    }

    private void loopOverBytes() {
        routine.idle(PACKET * Processor.ROUND);
    }

    private void pack(int channel, int message) {
        packet[0] = (byte) channel;
        for (int i = 1; i < PACKET; i++) {
            packet[i] = (byte) (message >> (PACKET - 1 - i) * Byte.SIZE);
        }
    }

    private void write(Link link, Runnable afterwards) {
        if (link.outgoing().isClosed()) {
            close(link);
            return;
        }
        routine.call(
                () -> {
                    long now = brick.time().now();
                    if (link.outgoing().send(packet, PACKET, now)) {
                        brick.observer().packetSent(now, packet, PACKET);
                        afterwards.run();
                    } else {
                        routine.until(() -> brick.tickAfter(1), () -> write(link, afterwards));
                    }
                });
    }
}
