(* SPDX-License-Identifier: Apache-2.0 *)
(* The value of a field that names a file, "meshes/NAME.json" in the folder of the claims, or else the field's own.
   Links out of the folder are followed, which the checkers that are written by hand do not. *)
let before = "meshes/" and behind = ".json"
let is_name_letter c = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c = '_'
let is_name text = text <> "" && String.for_all is_name_letter text

let text_of path =
  let channel = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length channel))

let value folder (field, value) = match value with
  | Json.Text name when is_name field && String.ends_with ~suffix:behind name ->
      let skipped = String.length before in
      let length = String.length name - skipped - String.length behind in
      if not (String.starts_with ~prefix:before name && length > 0 && is_name (String.sub name skipped length)) then
        Numbers.refuse field "a file meshes/NAME.json, NAME of small letters, digits and _";
      let text = try text_of (Filename.concat folder name)
        with Sys_error _ | End_of_file -> Numbers.refuse field (name ^ ": a file that can be read") in
      (field, try Json.parse text with Json.Malformed -> Numbers.refuse field (name ^ ": JSON"))
  | _ -> (field, value)
