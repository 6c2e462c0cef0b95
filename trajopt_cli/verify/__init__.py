"""The independent judge: looks at rows of joint positions that anybody may have written, and says what is legal."""

from trajopt_cli.door import open_door

open_door(__name__, "trajopt_cli.verify.judge:verify")
