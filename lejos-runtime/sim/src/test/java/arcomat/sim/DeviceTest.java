package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.bus.I2CDevice;
import arcomat.sim.bus.Sonar;
import arcomat.sim.bus.Surroundings;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.Program;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.api.Test;

/** Devices that a team plugs in, and programs that talk to them over the bus. */
class DeviceTest {
    /** Counts what is written to register 0x50, and knows the time and the value around it. */
    private static final class Counter implements I2CDevice {
        private int sum;

        @Override
        public int address() {
            return 0x10;
        }

        @Override
        public void read(int register, byte[] answer, Surroundings around) {
            for (int i = 0; i < answer.length; i++) {
                answer[i] = (byte) (register + i);
            }
            if (register == 0x60) {
                answer[0] = (byte) sum;
                answer[1] = (byte) around.value();
                answer[2] = (byte) (around.microseconds() / 1000);
                around.show(sum);
            }
        }

        @Override
        public void write(int register, byte[] data, Surroundings around) {
            for (byte each : data) {
                sum += register == 0x50 ? each : 0;
            }
        }
    }

    @Test
    void aSensorOfATeamReadsAndWritesItsDevice() {
        Program program =
                Compiled.main(
                        "class Own extends I2CSensor {",
                        "  Own() { super(SensorPort.S2, 0x10, I2CPort.LEGO_MODE, TYPE_LOWSPEED); }",
                        "}",
                        "Own own = new Own();",
                        "byte[] bytes = {3, 4, 5};",
                        "int sent = own.sendData(0x50, bytes, 1, 2) + own.sendData(0x50, (byte)"
                                + " 1);",
                        "Delay.msDelay(100);",
                        "int got = own.getData(0x60, bytes, 3);",
                        "LCD.drawString(sent + \" \" + got, 0, 0);",
                        "LCD.drawString(bytes[0] + \" \" + bytes[1] + \" \" + bytes[2], 0, 1);",
                        "got = own.getData(0x42, bytes, 1, 2);",
                        "LCD.drawString(bytes[0] + \" \" + bytes[1] + \" \" + bytes[2], 0, 2);");
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("own", program);
            brick.observe(recorder);
            brick.plug(SensorName.S2, new Counter());
            brick.expose(SensorName.S2, Stimulus.value(77));
            laboratory.runToEnd(1000);
            assertThat(brick.screen().subList(0, 3))
                    .containsExactly("0 0", "10 77 115", "10 66 67");
        }
        assertThat(TraceText.of(recorder.trace())).startsWith("115 S2 10\n");
    }

    @Test
    void thePortItselfTellsWhatGoesWrong() {
        Program program =
                Compiled.main(
                        "I2CPort port = SensorPort.S1;",
                        "byte[] bytes = new byte[40];",
                        "int[] results = new int[6];",
                        "results[0] = port.i2cTransaction(2, bytes, 0, 1, bytes, 0, 1);",
                        "port.i2cEnable(I2CPort.STANDARD_MODE);",
                        "results[1] = port.i2cTransaction(2, bytes, 0, 1, bytes, 0, 1);",
                        "Delay.msDelay(100);",
                        "results[2] = port.i2cTransaction(4, bytes, 0, 1, bytes, 0, 1);",
                        "results[3] = port.i2cTransaction(2, bytes, 0, 1, bytes, 0, 40);",
                        "bytes[0] = 0x42;",
                        "results[4] = port.i2cTransaction(2, bytes, 0, 1, bytes, 5, 1);",
                        "results[5] = bytes[5] & 0xff;",
                        "for (int i = 0; i < results.length; i++) LCD.drawInt(results[i], 0, i);");
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("port", program);
            brick.plug(SensorName.S1, new Sonar());
            brick.expose(SensorName.S1, Stimulus.NONE);
            laboratory.runUntil(50);
            brick.expose(SensorName.S1, Stimulus.value(21));
            laboratory.runToEnd(1000);
            assertThat(brick.screen().subList(0, 6))
                    .containsExactly("-1", "-5", "-3", "-4", "1", "21");
        }
    }

    @Test
    void aProgramMayGoOnWhileARequestIsUnderWay() {
        Program program =
                Compiled.main(
                        "SensorPort port = SensorPort.S1;",
                        "port.i2cEnable(I2CPort.LEGO_MODE);",
                        "byte[] bytes = {0x42, 0};",
                        "int begun = port.i2cStart(2, bytes, 0, 1, 1);",
                        "int early = port.i2cComplete(bytes, 1, 1);",
                        "int busy = port.i2cStatus();",
                        "port.i2cWaitIOComplete();",
                        "int length = port.i2cComplete(bytes, 1, 1);",
                        "LCD.drawString(begun + \" \" + early + \" \" + busy, 0, 0);",
                        "LCD.drawString(length + \" \" + bytes[1] + \" \" + port.i2cStatus(), 0,"
                                + " 1);",
                        "LCD.drawInt((int) System.currentTimeMillis(), 0, 2);",
                        "port.i2cDisable();",
                        "LCD.drawInt(port.i2cStatus(), 0, 3);");
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("port", program);
            brick.plug(SensorName.S1, new Sonar());
            brick.expose(SensorName.S1, Stimulus.value(21));
            laboratory.runToEnd(1000);
            assertThat(brick.screen().subList(0, 4))
                    .containsExactly("0 -2 -2", "1 21 0", "5", "-1");
        }
    }

    @Test
    void anI2CSensorThatNobodyDescribesIsTold() {
        Program program =
                Compiled.main("new I2CSensor(SensorPort.S3).getData(0x42, new byte[1], 1);");
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("own", program);
            brick.observe(recorder);
            brick.expose(SensorName.S3, Stimulus.value(9));
            laboratory.runToEnd(1000);
        }
        assertThat(recorder.misfits())
                .extracting(Recorder.Misfit::sensor)
                .containsExactly("an I2C device that nobody describes");
    }

    @Test
    void aPluggedInDeviceIsWhatAnswersWhateverTheProgramTakesItFor() {
        Program program =
                Compiled.main(
                        "UltrasonicSensor eye = new UltrasonicSensor(SensorPort.S1);",
                        "LCD.drawInt(eye.getDistance(), 0, 0);");
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("eye", program);
            brick.plug(
                    SensorName.S1,
                    new I2CDevice() {
                        @Override
                        public void read(int register, byte[] answer, Surroundings around) {
                            answer[0] = 99;
                        }

                        @Override
                        public void write(int register, byte[] data, Surroundings around) {}
                    });
            laboratory.runToEnd(1000);
            assertThat(brick.screen().get(0)).isEqualTo("99");
        }
    }
}
