// One video and the question. No answer counts before the video was seen to its end once.

const byId = (id) => document.getElementById(id);

export class Trial {
    /** @param {{onAnswer: (answer: {side: string, seconds: number, plays: number}) => void}} hooks */
    constructor({ onAnswer }) {
        this.onAnswer = onAnswer;
        this.video = byId("video");
        this.video.addEventListener("ended", () => this.ended());
        this.video.addEventListener("pause", () => this.paused());
        this.video.addEventListener("error", () => this.missing());
        this.video.addEventListener("loadedmetadata", () => {
            byId("screen").style.aspectRatio = `${this.video.videoWidth} / ${this.video.videoHeight}`;
        });
        byId("play").addEventListener("click", () => this.play());
        byId("left").addEventListener("click", () => this.answer("left"));
        byId("right").addEventListener("click", () => this.answer("right"));
        document.addEventListener("keydown", (event) => this.key(event));
    }

    /** Shows a trial's video, stopped at its start. */
    begin(trial, focus) {
        this.trial = trial;
        this.plays = 0;
        this.seenAt = null;
        byId("trial-title").textContent = `Video ${trial.number} of ${trial.of}`;
        byId("progress").value = trial.number - 1;
        byId("screen").classList.toggle("mirrored", trial.mirrored);
        byId("missing").hidden = true;
        this.video.src = `videos/${trial.pair.left}_${trial.pair.right}.mp4`;
        this.allow(false);
        byId("play").disabled = false;
        byId("play").textContent = "Play";
        this.say("Press Play, or the space bar. You answer when the video has ended.");
        if (focus) {
            byId("play").focus();
        }
    }

    /** Plays on from where the video is; from its start once it has ended. */
    async play() {
        byId("play").disabled = true;
        this.video.loop = false; // a browser's menu can set it, and then no end comes
        try {
            await this.video.play();
            this.say("Watch both sides \u2026");
        } catch {
            byId("play").disabled = false; // the browser refused, or the video is missing, which has said so itself
        }
    }

    /** A browser pauses a video for a media key, a call or a hidden page, too. */
    paused() {
        if (!this.video.ended && this.video.currentTime > 0) { // an answer has put the next video at its start
            byId("play").disabled = false;
            this.say("The video has stopped. Press the button, or the space bar, to go on.");
        }
    }

    ended() {
        this.plays += 1;
        this.seenAt ??= performance.now();
        this.allow(true);
        byId("play").disabled = false;
        byId("play").textContent = "Again";
        this.say("Which side flickered less? Left and right arrow keys answer, too.");
    }

    missing() {
        if (!this.trial) {
            return;
        }
        byId("missing").textContent = `videos/${this.trial.pair.left}_${this.trial.pair.right}.mp4 cannot be played: it is missing, or this browser does not know its format. Where ffmpeg is installed, \u201ccdr report --quick -o FOLDER\u201d makes all six beside a copy of this page, and \u201ccdr flicker --videos videos\u201d makes them alone.`;
        byId("missing").hidden = false;
        byId("play").disabled = true;
        this.say("");
    }

    answer(side) {
        if (this.seenAt === null) {
            return;
        }
        const seconds = (performance.now() - this.seenAt) / 1000;
        this.seenAt = null; // a second press answers nothing
        this.video.pause();
        this.onAnswer({ side, seconds, plays: this.plays });
    }

    key(event) {
        const busy = byId("trial").hidden || event.ctrlKey || event.metaKey || event.altKey || event.repeat ||
            /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) || event.target.closest("details"); // its tables scroll by arrows
        if (busy) {
            return;
        }
        if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
            event.preventDefault();
            this.answer(event.key === "ArrowLeft" ? "left" : "right");
        } else if (event.key === " " && !/^(BUTTON|SUMMARY|A)$/.test(event.target.tagName) && !byId("play").disabled) {
            event.preventDefault();
            this.play();
        }
    }

    allow(may) {
        byId("left").disabled = !may;
        byId("right").disabled = !may;
    }

    say(text) {
        byId("hint").textContent = text;
    }
}
