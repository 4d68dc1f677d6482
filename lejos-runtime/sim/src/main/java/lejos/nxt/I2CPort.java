package lejos.nxt;

/** A socket for a sensor that is asked over a bus of two wires. */
public interface I2CPort extends BasicSensorPort {
    int ALWAYS_ACTIVE = 2;
    int ERR_ABORT = -6;
    int ERR_BUSY = -2;
    int ERR_BUS_BUSY = -5;
    int ERR_FAULT = -3;
    int ERR_INVALID_LENGTH = -4;
    int ERR_INVALID_PORT = -1;
    int HIGH_SPEED = 8;
    int LEGO_MODE = 1;
    int MAX_IO = 32;
    int NO_RELEASE = 4;
    int STANDARD_MODE = 0;

    void i2cEnable(int mode);

    void i2cDisable();

    int i2cStatus();

    /** Sends bytes and reads some back: their number, or what went wrong. */
    int i2cTransaction(
            int deviceAddress,
            byte[] writeBuf,
            int writeOffset,
            int writeLen,
            byte[] readBuf,
            int readOffset,
            int readLen);
}
