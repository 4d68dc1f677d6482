package lejos.nxt.comm;

import arcomat.sim.device.Hardware;
import arcomat.sim.radio.Channel;
import arcomat.sim.radio.Link;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.InputStream;
import java.io.OutputStream;

import javax.microedition.io.StreamConnection;

/** A connection to another brick, for packets or, in mode RAW, for bytes without borders. */
public abstract class NXTConnection implements StreamConnection {
    public static final int PACKET = 0;
    public static final int LCP = 1;
    public static final int RAW = 2;

    private static final Hardware BRICK = Hardware.of(NXTConnection.class);
    private static final int END = -1;

    private final Link link;
    private int mode;

    NXTConnection(Link link, int mode) {
        this.link = link;
        this.mode = mode;
    }

    public void setIOMode(int mode) {
        this.mode = mode;
    }

    public String getAddress() {
        return link.partner();
    }

    @Override
    public void close() {
        BRICK.called();
        link.close();
    }

    public int available() {
        return available(0);
    }

    /**
     * Bytes of the packet that is arriving: those that can be read without waiting (0), all that
     * have not been read (1), or its whole length (2); 0 if none is arriving.
     */
    public int available(int what) {
        long now = BRICK.called().time().now();
        Channel channel = link.incoming();
        return switch (what) {
            case 1 -> channel.left(now);
            case 2 -> channel.length(now);
            default -> channel.arrived(now);
        };
    }

    public int write(byte[] data, int len) {
        return write(data, len, true);
    }

    /** The number of bytes sent; 0 if there is no room and no time to wait; -1 when closed. */
    public int write(byte[] data, int len, boolean wait) {
        Channel channel = link.outgoing();
        int length = Math.min(len, channel.longest());
        while (length > 0 && !channel.isClosed()) {
            if (channel.send(data, length, BRICK.called().time().now())) {
                BRICK.observer().packetSent(BRICK.time().now(), data, length);
                return length;
            }
            if (!wait) {
                return 0;
            }
            BRICK.time().waitUntil(BRICK.tickAfter(1));
        }
        return length > 0 ? END : 0;
    }

    public int sendPacket(byte[] buf, int bufLen) {
        return write(buf, bufLen, false);
    }

    public int read(byte[] data, int len) {
        return read(data, len, true);
    }

    /**
     * Bytes read; 0 for none yet; -1 when closed. Where it waits, it waits for the whole packet or
     * a full buffer. What does not fit is left for the next time.
     */
    public int read(byte[] data, int len, boolean wait) {
        Channel channel = link.incoming();
        while (!isThere(channel, len, wait)) {
            if (channel.isFinished()) {
                return END;
            }
            if (!wait || len == 0) {
                return 0;
            }
            BRICK.time().waitUntil(BRICK.tickAfter(1));
        }
        return take(channel, data, len);
    }

    private boolean isThere(Channel channel, int len, boolean wait) {
        long now = BRICK.called().time().now();
        boolean toTheEnd = wait && mode != RAW;
        int wanted = toTheEnd ? Math.min(len, channel.left(now)) : Math.min(len, 1);
        return wanted > 0 && channel.arrived(now) >= wanted;
    }

    private int take(Channel channel, byte[] data, int len) {
        long now = BRICK.time().now();
        int taken = Math.min(len, channel.arrived(now));
        channel.take(data, taken);
        BRICK.observer().packetReceived(now, data, taken);
        return taken;
    }

    public int readPacket(byte[] buf, int len) {
        return read(buf, len, false);
    }

    /** As on the brick, streams are for bytes without borders. */
    @Override
    public InputStream openInputStream() {
        return new NXTInputStream(this);
    }

    @Override
    public OutputStream openOutputStream() {
        return new NXTOutputStream(this);
    }

    @Override
    public DataInputStream openDataInputStream() {
        return new DataInputStream(openInputStream());
    }

    @Override
    public DataOutputStream openDataOutputStream() {
        return new DataOutputStream(openOutputStream());
    }

    /** Like {@link #read}, leaving what does not fit for the next time. */
    int readBytes(byte[] data, int len) {
        int before = mode;
        mode = RAW;
        int taken = read(data, len, true);
        mode = before;
        return taken;
    }
}
