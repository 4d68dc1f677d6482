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
    private static final int LOST = -2;

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

    public void close() {
        BRICK.called();
        link.close();
    }

    public int available() {
        return available(0);
    }

    /** Bytes that can be read without waiting; in this simulation of one packet only. */
    public int available(int what) {
        return Math.max(0, link.incoming().arrived(BRICK.called().time().now()));
    }

    public int write(byte[] data, int len) {
        return write(data, len, true);
    }

    /** The number of bytes sent; 0 if there is no room and nothing to wait for; -1 when closed. */
    public int write(byte[] data, int len, boolean wait) {
        Channel channel = link.outgoing();
        int length = Math.min(len, channel.longest());
        while (!channel.isClosed()) {
            if (channel.send(data, length, BRICK.called().time().now())) {
                BRICK.observer().packetSent(BRICK.time().now(), data, length);
                return length;
            }
            if (!wait) {
                return 0;
            }
            BRICK.time().waitUntil(BRICK.tickAfter(1));
        }
        return END;
    }

    public int sendPacket(byte[] buf, int bufLen) {
        return write(buf, bufLen, false);
    }

    public int read(byte[] data, int len) {
        return read(data, len, true);
    }

    /**
     * Bytes read; 0 for none yet; -1 when closed; -2 when the packet was longer than the buffer.
     */
    public int read(byte[] data, int len, boolean wait) {
        Channel channel = link.incoming();
        while (channel.arrived(BRICK.called().time().now()) < 0) {
            if (channel.isFinished()) {
                return END;
            }
            if (!wait) {
                return 0;
            }
            BRICK.time().waitUntil(BRICK.tickAfter(1));
        }
        return take(channel, data, len);
    }

    private int take(Channel channel, byte[] data, int len) {
        boolean tooLong = mode == PACKET && channel.arrived(BRICK.time().now()) > len;
        int taken = channel.take(data, 0, len);
        BRICK.observer().packetReceived(BRICK.time().now(), data, taken);
        if (tooLong) {
            channel.drop();
        }
        return tooLong ? LOST : taken;
    }

    public int readPacket(byte[] buf, int len) {
        return read(buf, len, false);
    }

    /** As on the brick, streams are for bytes without borders. */
    public InputStream openInputStream() {
        return new NXTInputStream(this);
    }

    public OutputStream openOutputStream() {
        return new NXTOutputStream(this);
    }

    public DataInputStream openDataInputStream() {
        return new DataInputStream(openInputStream());
    }

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
